// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_exceptions_h
#define seiche_utilities_exceptions_h

#include <stdexcept>
#include <string>

namespace seiche
{
  /// What the program returns to the shell.
  enum class ExitCode : int
  {
    finished  = 0,
    internal  = 1,
    input     = 2,
    numerical = 3,
    files     = 4,
    stopped   = 5,
    rejected  = 6 ///< finished, but fails a verdict
  };

  /**
   * @brief An error that a user can act on.
   *
   * The text names what was read or tried, where, and what to change; it is
   * printed as it is, once, by main().
   */
  class Error : public std::runtime_error
  {
  public:
    Error(const ExitCode code, const std::string &message)
      : std::runtime_error(message)
      , exit_code(code)
    {}

    const ExitCode exit_code;
  };

  /// Parameter file, command line or reference table: exit code 2.
  class InputError : public Error
  {
  public:
    explicit InputError(const std::string &message)
      : Error(ExitCode::input, message)
    {}
  };

  /// A step that fails at the smallest step size, a lost point: exit code 3.
  class NumericalError : public Error
  {
  public:
    explicit NumericalError(const std::string &message)
      : Error(ExitCode::numerical, message)
    {}
  };

  /// A file that cannot be written or read: exit code 4.
  class FileError : public Error
  {
  public:
    explicit FileError(const std::string &message)
      : Error(ExitCode::files, message)
    {}
  };
} // namespace seiche

#endif
