// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_result_names_h
#define seiche_utilities_result_names_h

#include <string>

/**
 * @brief Names of all that a run writes into its folder. Who writes takes them
 * from here, and so does who moves the results of an earlier run aside.
 */
namespace seiche::result_names
{
  constexpr const char *statistics = "statistics.csv";
  constexpr const char *summary    = "summary.json";
  constexpr const char *parameters = "parameters.prm";
  constexpr const char *log        = "run.log";
  constexpr const char *progress   = "progress.json";
  constexpr const char *timing     = "timing.txt";
  constexpr const char *references = "methods.bib";
  constexpr const char *paraview   = "paraview_state.py";
  constexpr const char *probes     = "probes.csv";
  constexpr const char *failure    = "failure"; ///< a folder

  // series of frames
  constexpr const char *points  = "points";
  constexpr const char *grid    = "grid";
  constexpr const char *surface = "surface";
  constexpr const char *walls   = "walls";

  /// Samples of a probe.
  std::string
  samples(const std::string &probe);

  /// The list of a series' frames, for ParaView.
  std::string
  index(const std::string &series);

  /// A frame without the ending of its file.
  std::string
  frame(const std::string &series, const unsigned int number);

  /// The part of a frame that a rank writes.
  std::string
  piece(const std::string &frame, const unsigned int rank);

  std::string
  checkpoint(const unsigned int step);

  bool
  is_checkpoint(const std::string &name);

  /// True for all of these names, and for files that were being written.
  bool
  is_result(const std::string &name);
} // namespace seiche::result_names

#endif
