// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_growing_file_h
#define seiche_utilities_growing_file_h

#include <cstddef>
#include <string>

namespace seiche
{
  /**
   * @brief A text file that grows by a line a step (statistics, probes, log).
   *
   * The lines so far stay readable while the run goes on. Each append is
   * flushed and checked; FileError on the first short write.
   */
  class GrowingFile
  {
  public:
    GrowingFile() = default;
    ~GrowingFile();
    GrowingFile(const GrowingFile &) = delete;
    GrowingFile &
    operator=(const GrowingFile &) = delete;

    void
    open(const std::string &filename);
    /// Go on with a file of which the first @p length bytes count: what comes
    /// after them is cut off. FileError if it is shorter.
    void
    continue_at(const std::string &filename, const std::size_t length);
    bool
    is_open() const;
    /// Number of bytes; 0 if no file is open.
    std::size_t
    length() const
    {
      return bytes;
    }
    /// What was appended so far survives a power cut. Local.
    void
    synchronise();
    /// Append the text (with its line end). Local.
    void
    append(const std::string &text);
    /// Flush to the disk and close, checked.
    void
    close();

  private:
    std::string filename;
    int         descriptor = -1;
    std::size_t bytes      = 0;
  };
} // namespace seiche

#endif
