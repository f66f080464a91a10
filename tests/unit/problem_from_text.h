// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_unit_problem_from_text_h
#define tests_unit_problem_from_text_h

#include <seiche/simulation/problem.h>

#include <string>

#include "scene_from_text.h"

/// What a ProblemFromText is made from.
template <int dim>
struct PlannedText
{
  PlannedText(const std::string &text,
              const std::string &density,
              const std::string &bulk_modulus)
    : input(file_with("set Dimension = " + std::to_string(dim) +
                      "\nsubsection Time\n set End time = 1\n set Step = 0.01"
                      "\nend\nsubsection Fluid\n set Density = " +
                      density +
                      "\n set Dynamic viscosity = 0\n set Bulk modulus = " +
                      bulk_modulus + "\nend\n" + text),
            {})
    , planned(input, MPI_COMM_WORLD)
  {}

  const seiche::InputFile         input;
  const seiche::PlannedScene<dim> planned;
  seiche::TimerTree               time;
};

/// The objects of a scene of which a test writes what matters to it: grid,
/// bodies, and what is not a default. The fluid is inviscid.
template <int dim>
class ProblemFromText : private PlannedText<dim>, public seiche::Problem<dim>
{
public:
  /// @p density [kg/m^3], @p bulk_modulus [Pa]
  explicit ProblemFromText(const std::string &text,
                           const std::string &density      = "1000",
                           const std::string &bulk_modulus = "infinite")
    : PlannedText<dim>(text, density, bulk_modulus)
    , seiche::Problem<dim>(this->planned, this->time)
  {}
};

#endif
