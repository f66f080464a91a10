// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/embedded_files.h>
#include <seiche/utilities/references.h>

#include <stdexcept>
#include <utility>

namespace seiche
{
  namespace
  {
    /// Keys and entries. An entry begins with @ at the start of a line.
    std::vector<std::pair<std::string, std::string>>
    read_entries()
    {
      const std::string text = embedded_files("references").at(0).text;

      std::vector<std::pair<std::string, std::string>> entries;
      for (std::size_t at = text.find("\n@"); at != std::string::npos;)
        {
          const std::size_t begin = at + 1;
          at                      = text.find("\n@", begin);
          const std::size_t end   = text.find("\n}\n", begin) + 3;
          const std::size_t key   = text.find('{', begin) + 1;
          entries.emplace_back(text.substr(key, text.find(',', key) - key),
                               text.substr(begin, end - begin));
        }
      return entries;
    }

    const std::vector<std::pair<std::string, std::string>> &
    entries()
    {
      static const auto all = read_entries();
      return all;
    }
  } // namespace

  std::string
  reference(const std::string &key)
  {
    for (const auto &[of_entry, text] : entries())
      if (of_entry == key)
        return text;
    throw std::out_of_range("doc/references.bib has no entry " + key);
  }

  std::vector<std::string>
  reference_keys()
  {
    std::vector<std::string> keys;
    for (const auto &entry : entries())
      keys.push_back(entry.first);
    return keys;
  }
} // namespace seiche
