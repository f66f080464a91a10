// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_lines.h>
#include <seiche/utilities/regular_file.h>

#include <deal.II/base/utilities.h>

#include <array>
#include <fstream>

namespace seiche
{
  namespace
  {
    using dealii::Utilities::trim;

    // A scene is some hundred lines; what is larger is not a scene.
    constexpr std::uintmax_t largest_file = 16u << 20;

    /// The whole file; the problem as text if it cannot be one of ours.
    std::string
    file_contents(const std::string &filename, std::string &problem)
    {
      problem = problem_of_file(filename, largest_file);
      if (!problem.empty())
        return "";

      // the stream's own read() reports what the system refuses to read
      std::ifstream          stream(filename, std::ios::binary);
      std::string            text;
      std::array<char, 4096> block;
      while (stream.read(block.data(), block.size()) || stream.gcount() > 0)
        text.append(block.data(), stream.gcount());
      if (!stream.eof())
        problem = "this file cannot be read; check its permissions";
      else if (text.find('\0') != std::string::npos)
        problem = "this is not a text file";
      else if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        problem = "this file is empty; a scene needs at least \"set Dimension "
                  "= 2\" and its mandatory entries";
      else if (text.compare(0, 3, "\xEF\xBB\xBF") == 0)
        text.erase(0, 3); // mark of some editors
      return text;
    }
  } // namespace



  InputLines
  read_lines(const std::string &filename)
  {
    InputLines        result;
    const std::string contents = file_contents(filename, result.problem);
    if (!result.problem.empty())
      return result;
    InputLine line;
    for (std::size_t begin = 0; begin < contents.size();)
      {
        const std::size_t end =
          std::min(contents.find('\n', begin), contents.size());
        std::string piece = contents.substr(begin, end - begin);
        begin             = end + 1;
        ++result.n_lines;
        if (line.text.empty())
          line.number = result.n_lines;
        // a backslash within a comment continues nothing
        piece                = trim(piece.substr(0, piece.find('#')));
        const bool continued = !piece.empty() && piece.back() == '\\';
        if (continued)
          piece.pop_back();
        line.text += piece;
        if (continued && begin < contents.size())
          continue;
        line.text = trim(line.text);
        if (!line.text.empty())
          result.lines.push_back(line);
        line.text.clear();
      }
    return result;
  }
} // namespace seiche
