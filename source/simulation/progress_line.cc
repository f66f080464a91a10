// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/progress_line.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <iostream>

namespace seiche
{
  namespace
  {
    std::size_t
    terminal_width()
    {
      winsize size{};
      return (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1) ?
               size.ws_col - 1 :
               200;
    }
  } // namespace



  ProgressLine::ProgressLine()
    : on_terminal(isatty(STDOUT_FILENO) == 1)
  {}



  void
  ProgressLine::show(const std::string &text)
  {
    if (!on_terminal)
      {
        std::cout << text << std::endl;
        return;
      }
    std::string       line      = text.substr(0, terminal_width());
    const std::size_t new_width = line.size();
    if (new_width < width)
      line.append(width - new_width, ' ');
    width = new_width;
    std::cout << '\r' << line << std::flush;
  }



  void
  ProgressLine::end()
  {
    if (width > 0)
      std::cout << std::endl;
    width = 0;
  }
} // namespace seiche
