// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_expression_text_h
#define seiche_scene_expression_text_h

#include <set>
#include <string>

namespace seiche
{
  /// What muParser would accept in an expression although it cannot be meant;
  /// the text of the problem, or empty. Fills the names that occur. Local.
  std::string
  problem_in_expression(const std::string &text, std::set<std::string> &names);
} // namespace seiche

#endif
