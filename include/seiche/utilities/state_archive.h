// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_state_archive_h
#define seiche_utilities_state_archive_h

#include <seiche/utilities/exceptions.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief Named values that a run carries from step to step.
   *
   * One function of a class both saves and loads, so that the two cannot
   * disagree:
   * @code
   *   archive("time", time); // writes time, or reads it
   * @endcode
   * Values: numbers, texts, pairs, arrays and vectors of them. Doubles and
   * 64-bit integers come back exactly, also those that are not finite. Local.
   */
  class StateArchive
  {
  public:
    /// An empty one, to be saved into.
    StateArchive() = default;

    /// One to be loaded from: what bytes() gave. FileError if it is none.
    explicit StateArchive(const std::vector<std::uint8_t> &bytes)
      : is_loading(true)
    {
      try
        {
          values = nlohmann::json::from_cbor(bytes);
        }
      catch (const nlohmann::json::exception &error)
        {
          throw FileError(std::string("its state cannot be read: ") +
                          error.what());
        }
    }

    StateArchive(const StateArchive &) = delete;
    StateArchive &
    operator=(const StateArchive &) = delete;

    /// The values in CBOR (RFC 8949).
    std::vector<std::uint8_t>
    bytes() const
    {
      return nlohmann::json::to_cbor(values);
    }

    bool
    loading() const
    {
      return is_loading;
    }

    /// Save or load one value. FileError if it is not there to be loaded.
    template <typename T>
    void
    operator()(const std::string &name, T &value)
    {
      if (!is_loading)
        {
          (*section_values)[name] = value;
          return;
        }
      try
        {
          section_values->at(name).get_to(value);
        }
      catch (const nlohmann::json::exception &)
        {
          throw FileError("the checkpoint has no valid value of \"" + name +
                          "\".");
        }
    }

    /// Call @p content, whose values get names of their own. Not called when
    /// the section is not there to be loaded: its owner is new to the run.
    template <typename Content>
    void
    section(const std::string &name, const Content &content)
    {
      if (is_loading && !section_values->contains(name))
        return;
      nlohmann::json *const outer = section_values;
      section_values              = &(*section_values)[name];
      content();
      section_values = outer;
    }

  private:
    nlohmann::json  values         = nlohmann::json::object();
    nlohmann::json *section_values = &values;
    bool            is_loading     = false;
  };
} // namespace seiche

#endif
