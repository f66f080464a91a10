// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_body_stops_h
#define seiche_solve_body_stops_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace seiche
{
  /// A place where bodies have come so near to something that they must not
  /// come nearer in this step.
  struct BodyStop
  {
    /// By what each free direction opens the gap: rate of the gap over that of
    /// the direction, [-] or [m].
    std::vector<double> way;
    double              rate;  ///< of the gap at the start of the step [m/s]
    double              least; ///< at its end [m/s]
  };

  /**
   * @brief Forces of stops on bodies: none pulls, and none acts where the gap
   * opens faster than it must (Signorini's conditions for rates; Moreau 1988).
   */
  class BodyStops
  {
  public:
    /// For a step of size @p step [s] of bodies with so many free directions.
    void
    begin(std::vector<BodyStop> list,
          const double          step,
          const unsigned int    n_directions);

    /// True if with these accelerations a gap opens less than it must; never
    /// after solve(), whose forces see to it.
    bool
    are_missing(const std::vector<double> &accelerations) const;

    /// Forces for accelerations that change by @p inverse (@p load + forces()),
    /// by projected Gauss-Seidel iterations.
    void
    solve(const dealii::FullMatrix<double> &inverse,
          const dealii::Vector<double>     &load,
          const std::vector<double>        &accelerations);

    /// On each free direction [N, N m]; zero before solve().
    const dealii::Vector<double> &
    forces() const
    {
      return sums;
    }

  private:
    /// Rate of a gap at the end of the step, over what it must be.
    double
    slack(const BodyStop &stop, const std::vector<double> &accelerations) const;

    std::vector<BodyStop>  stops;
    double                 dt     = 0.;
    bool                   solved = false;
    dealii::Vector<double> sums;
  };
} // namespace seiche

#endif
