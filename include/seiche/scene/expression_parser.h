// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_expression_parser_h
#define seiche_scene_expression_parser_h

#include <muParser.h>

#include <string>
#include <vector>

namespace seiche
{
  /// muParser as expressions use it.
  namespace expression_parser
  {
    /// muParser's functions and those that deal.II adds to them.
    mu::Parser
    parser_with_functions();

    /// x, y, z, t.
    const std::vector<std::string> &
    variables();

    /// The components, with a function's name next to its parenthesis, as
    /// muParser wants it.
    std::vector<std::string>
    components_of(const std::string &text);

    /// Without the full stop.
    std::string
    message_of(const mu::ParserError &error);
  } // namespace expression_parser
} // namespace seiche

#endif
