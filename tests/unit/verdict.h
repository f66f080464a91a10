// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_unit_verdict_h
#define tests_unit_verdict_h

/// How tests say whether a property holds.
inline const char *
verdict(const bool right)
{
  return right ? "yes" : "NO";
}

#endif
