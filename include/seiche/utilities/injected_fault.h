// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_injected_fault_h
#define seiche_utilities_injected_fault_h

namespace seiche
{
  /// Numerical faults that the tests of reliability ask for.
  enum class Fault
  {
    residual, ///< a residual that is not a number
    update,   ///< a linear solve that gives what is not a number
    stall,    ///< a linear solver that does not converge, on all ranks
    singular, ///< a matrix that cannot be factorised, on all ranks
    position, ///< a point whose position is not a number
    velocity, ///< a point whose velocity is not a number
    speed     ///< a point of absurd speed
  };

  /**
   * @brief Whether the environment asks for this fault at this call. Local.
   *
   * SEICHE_FAULT = "KIND CALL [COUNT [RANK]]": at CALL of this kind, counted
   * from 1, and COUNT - 1 later ones (default 1), on RANK only (default: on
   * all). Only for tests; what it holds is not checked.
   */
  bool
  is_injected(const Fault fault);
} // namespace seiche

#endif
