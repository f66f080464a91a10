# SPDX-License-Identifier: LGPL-2.1-or-later
# Scenes by chance; how many: SEICHE_RELIABILITY (random_scenes.py).
add_test(NAME reliability/random_scenes
  COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/random_scenes.py
    $<TARGET_FILE:seiche>)
set_tests_properties(reliability/random_scenes PROPERTIES
  LABELS reliability TIMEOUT 0 ENVIRONMENT "${seiche_test_environment}")
