// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_unit_block_in_tank_h
#define tests_unit_block_in_tank_h

#include "problem_from_text.h"

/// Edges of the cells [m].
template <int dim>
dealii::Tensor<1, dim>
cell_edges()
{
  dealii::Tensor<1, dim> result;
  for (unsigned int d = 0; d < dim; ++d)
    result[d] = 0.1 * (d + 1);
  return result;
}

template <int dim>
std::string
at(const double cells, const double height)
{
  std::string text;
  for (unsigned int d = 0; d < dim; ++d)
    text += (d ? ", " : "") + std::to_string((d == dim - 1 ? height : cells) *
                                             cell_edges<dim>()[d]);
  return text;
}

template <int dim>
std::string
at(const double cells)
{
  return at<dim>(cells, cells);
}

/// A block of 2 cells in the middle of a full tank of 6, open at the top;
/// @p refined: cells of half the size from the middle to the right; @p level of
/// the water [cells].
template <int dim>
std::string
block_in_tank(const bool         refined,
              const std::string &more,
              const double       level = 6.)
{
  const std::string cells[] = {"\n set Cells x = 6",
                               "\n set Cells y = 6",
                               "\n set Cells z = 6"};
  std::string text = "subsection Walls\n set Top = open\nend\nsubsection Grid";
  for (unsigned int d = 0; d < dim; ++d)
    text += cells[d];
  text +=
    "\n set Lower corner = " + at<dim>(0.) +
    "\n set Upper corner = " + at<dim>(6.) + "\nend\n" + more +
    "subsection Obstacle block\n set Condition = slip\n set Friction = 0.01"
    "\n set Lower corner = " +
    at<dim>(2.) + "\n set Upper corner = " + at<dim>(4.) +
    "\nend\nsubsection Body force\n set Acceleration = " +
    (dim == 2 ? "0; -10" : "0; 0; -10") +
    "\nend\nsubsection Fluid body a\n set Lower corner = " + at<dim>(0.) +
    "\n set Upper corner = " + at<dim>(6., level) + "\nend\n";
  if (refined)
    text += "subsection Refinement fluid\n set Criterion = fluid\n"
            "set Level = 0\nend\n"
            "subsection Refinement right\n set Criterion = box\n"
            "set Level = 1\n set Lower corner = " +
            at<dim>(3.) + "\n set Upper corner = " + at<dim>(6.) + "\nend\n";
  return text;
}

/// Of the points of this rank [kg m/s].
template <int dim>
dealii::Tensor<1, dim>
momentum_of(const seiche::PointCloud<dim> &points)
{
  using seiche::PointColumn;
  dealii::Tensor<1, dim> result;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (unsigned int d = 0; d < dim; ++d)
      result[d] += points.data(PointColumn::mass)[p] *
                   points.data(PointColumn::velocity, d)[p];
  return result;
}

#endif
