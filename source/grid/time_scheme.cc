// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/time_scheme.h>
#include <seiche/parameters/input_file.h>

#include <deal.II/base/parameter_handler.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Apply f(i) to own and ghost entries of a vector's layout.
    template <typename Vector, typename Function>
    void
    for_each_local(const Vector &layout, const Function &f)
    {
      const unsigned int n = layout.locally_owned_size() +
                             layout.get_partitioner()->n_ghost_indices();
      for (unsigned int i = 0; i < n; ++i)
        f(i);
    }

    /**
     * Newmark (beta, gamma) with Bossak's weighted inertia (doc/theory.md
     * (3.1)): a = c_a u + a^, v = c_v u + v^, inertia (1 - alpha) a + alpha
     * a_n. alpha = 0, beta = 1/4, gamma = 1/2: the scheme of the founding
     * paper.
     */
    template <int dim>
    class Bossak : public TimeScheme<dim>
    {
    public:
      using Vector = typename TimeScheme<dim>::Vector;

      explicit Bossak(const double alpha)
        : alpha(alpha)
        , beta((1. - alpha) * (1. - alpha) / 4.)
        , gamma(0.5 - alpha)
      {}

      StepCoefficients
      coefficients(const double dt) const override
      {
        StepCoefficients c;
        c.dt      = dt;
        c.theta   = 1.;
        c.inertia = (1. - alpha) / (beta * dt * dt);
        c.rate    = gamma / (beta * dt);
        return c;
      }

      VolumeFactors
      volume_factors() const override
      {
        return {};
      }

      bool
      needs_acceleration() const override
      {
        return true;
      }

      double
      pressure_time() const override
      {
        return 1.;
      }

      double
      error_constant() const override
      {
        return beta - 1. / 6.;
      }

      void
      offsets(const GridState<dim> &state,
              const double          dt,
              Vector               &inertia_offset,
              Vector               &rate_offset) const override
      {
        for_each_local(state.velocity_start, [&](const unsigned int i) {
          const double v = state.velocity_start.local_element(i);
          const double a = state.acceleration_n.local_element(i);
          inertia_offset.local_element(i) =
            (1. - alpha) * acceleration_offset(v, a, dt) + alpha * a;
          rate_offset.local_element(i) = velocity_offset(v, a, dt);
        });
        inertia_offset.update_ghost_values();
        rate_offset.update_ghost_values();
      }

      void
      finish(GridState<dim> &state) const override
      {
        const double dt = state.dt;
        for_each_local(state.velocity_start, [&](const unsigned int i) {
          const double u = state.displacement().local_element(i);
          const double v = state.velocity_start.local_element(i);
          const double a = state.acceleration_n.local_element(i);
          state.velocity_np1.local_element(i) =
            gamma / (beta * dt) * u + velocity_offset(v, a, dt);
          state.acceleration_np1.local_element(i) =
            u / (beta * dt * dt) + acceleration_offset(v, a, dt);
        });
        state.velocity_np1.update_ghost_values();
        state.acceleration_np1.update_ghost_values();
      }

    private:
      double
      acceleration_offset(const double v, const double a, const double dt) const
      {
        return -v / (beta * dt) - (0.5 / beta - 1.) * a;
      }

      double
      velocity_offset(const double v, const double a, const double dt) const
      {
        return (1. - gamma / beta) * v + dt * (1. - 0.5 * gamma / beta) * a;
      }

      const double alpha, beta, gamma;
    };

    /**
     * Generalized midpoint with theta = 1/(1 + rho_inf) (doc/theory.md (3.1)):
     * a = (v_1 - v_0)/dt, u = dt (theta v_1 + (1 - theta) v_0), forces in the
     * theta configuration, constraint at the end of the step, the strain of a
     * compressible fluid there or in the theta configuration.
     */
    template <int dim>
    class GeneralizedMidpoint : public TimeScheme<dim>
    {
    public:
      using Vector = typename TimeScheme<dim>::Vector;

      GeneralizedMidpoint(const double rho_infinity,
                          const bool   second_order_pressure,
                          const bool   elastic_at_end)
        : theta(1. / (1. + rho_infinity))
        , jerk(second_order_pressure ? 1. / 12. : 0.)
        , elastic_time(elastic_at_end ? 1. : theta)
      {}

      StepCoefficients
      coefficients(const double dt) const override
      {
        StepCoefficients c;
        c.dt      = dt;
        c.theta   = theta;
        c.inertia = 1. / (theta * dt * dt);
        c.rate    = 1. / dt;
        return c;
      }

      VolumeFactors
      volume_factors() const override
      {
        return {/*start_divergence=*/0.5 - theta, jerk, elastic_time};
      }

      bool
      needs_acceleration() const override
      {
        return false;
      }

      double
      pressure_time() const override
      {
        return 0.5;
      }

      double
      error_constant() const override
      {
        return 1. / 12.; // theta = 1/2; others are of first order
      }

      void
      offsets(const GridState<dim> &state,
              const double          dt,
              Vector               &inertia_offset,
              Vector               &rate_offset) const override
      {
        for_each_local(state.velocity_start, [&](const unsigned int i) {
          inertia_offset.local_element(i) =
            -state.velocity_start.local_element(i) / (theta * dt);
          rate_offset.local_element(i) = 0.;
        });
        inertia_offset.update_ghost_values();
        rate_offset.update_ghost_values();
      }

      void
      finish(GridState<dim> &state) const override
      {
        const double dt = state.dt;
        for_each_local(state.velocity_start, [&](const unsigned int i) {
          const double v0 = state.velocity_start.local_element(i);
          const double v1 =
            (state.displacement().local_element(i) / dt - (1. - theta) * v0) /
            theta;
          state.velocity_np1.local_element(i)     = v1;
          state.acceleration_np1.local_element(i) = (v1 - v0) / dt;
        });
        state.velocity_np1.update_ghost_values();
        state.acceleration_np1.update_ghost_values();
      }

    private:
      const double theta, jerk, elastic_time;
    };

    /// One row of the table of schemes.
    template <int dim>
    struct SchemeEntry
    {
      const char *name;
      const char *entry; ///< of subsection "Time" that it alone reads, or empty
      const char *papers; ///< keys of doc/references.bib
      std::unique_ptr<TimeScheme<dim>> (*make)(const TimeSchemeParameters &,
                                               const bool is_incompressible);
    };

    template <int dim>
    constexpr std::array<SchemeEntry<dim>, 3> scheme_table = {
      {{"generalized midpoint",
        "Rho infinity",
        "",
        [](const TimeSchemeParameters &p,
           const bool is_incompressible) -> std::unique_ptr<TimeScheme<dim>> {
          return std::make_unique<GeneralizedMidpoint<dim>>(
            p.rho_infinity,
            p.pressure_order == "second" && p.rho_infinity == 1. &&
              is_incompressible,
            p.is_elastic_at_end());
        }},
       {"bossak",
        "Bossak alpha",
        "wood1980",
        [](const TimeSchemeParameters &p,
           const bool) -> std::unique_ptr<TimeScheme<dim>> {
          return std::make_unique<Bossak<dim>>(p.bossak_alpha);
        }},
       {"newmark",
        "",
        "newmark1959",
        [](const TimeSchemeParameters &,
           const bool) -> std::unique_ptr<TimeScheme<dim>> {
          return std::make_unique<Bossak<dim>>(0.);
        }}}};

    std::string
    scheme_names()
    {
      std::string names;
      for (const auto &entry : scheme_table<2>)
        names += (names.empty() ? "" : "|") + std::string(entry.name);
      return names;
    }
  } // namespace

  void
  TimeSchemeParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.add_parameter("Scheme",
                      scheme,
                      "Time integration. generalized midpoint: second order "
                      "for Rho infinity = 1, no acceleration history; bossak "
                      "and newmark (the founding paper's) carry an "
                      "acceleration on the points",
                      Patterns::Selection(scheme_names()));
    prm.add_parameter("Rho infinity",
                      rho_infinity,
                      "Spectral radius of the generalized midpoint scheme at "
                      "infinite frequency, theta = 1/(1 + rho): 1 keeps "
                      "energy, 0 is backward Euler [-]",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Bossak alpha",
                      bossak_alpha,
                      "Weight of the old acceleration in Bossak's inertia [-]",
                      Patterns::Double(-1. / 3., 0.));
    prm.add_parameter("Pressure order",
                      pressure_order,
                      "Order in the step of the pressure of the generalized "
                      "midpoint scheme with Rho infinity = 1 (below 1 all is "
                      "of first order) with infinite Bulk modulus. second: the "
                      "constraint leaves the velocity at the end of the step "
                      "without divergence; first: it keeps the volume of the "
                      "step's own path",
                      Patterns::Selection("first|second"));
    prm.add_parameter("Elastic pressure",
                      elastic_pressure,
                      "When the volume ratio in p = -kappa (J - 1) is taken, "
                      "finite Bulk modulus only. end: at the end of the step, "
                      "first order, damps sound; middle: between start and end "
                      "as other forces, second order for Rho infinity = 1, for "
                      "sound that the steps resolve, c dt/h about 1 and less",
                      Patterns::Selection("end|middle"));
    prm.leave_subsection();
  }

  void
  TimeSchemeParameters::check(const InputFile &input,
                              const bool       is_incompressible) const
  {
    const std::string section = "Time/";
    for (const auto &row : scheme_table<2>)
      {
        input.read_only_if(scheme == row.name,
                           section + row.entry,
                           section + "Scheme = " + row.name);
        if (scheme == row.name)
          input.cites(row.papers);
      }
    input.read_only_if(!needs_acceleration() && is_second_order() &&
                         is_incompressible,
                       section + "Pressure order",
                       "Scheme = generalized midpoint, Rho infinity = 1, the "
                       "mixed form and an infinite Fluid/Bulk modulus");
  }

  bool
  TimeSchemeParameters::needs_acceleration() const
  {
    return make_time_scheme<2>(*this, /*is_incompressible=*/true)
      ->needs_acceleration();
  }

  template <int dim>
  void
  TimeScheme<dim>::predict(GridState<dim> &state) const
  {
    for_each_local(state.velocity_start, [&](const unsigned int i) {
      state.displacement().local_element(i) =
        state.dt * state.velocity_start.local_element(i);
    });
    if (state.has_pressure())
      for_each_local(state.pressure_guess, [&](const unsigned int i) {
        state.pressure().local_element(i) =
          state.pressure_guess.local_element(i);
      });
    state.solution.update_ghost_values();
  }

  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_time_scheme(const TimeSchemeParameters &parameters,
                   const bool                  is_incompressible)
  {
    for (const auto &entry : scheme_table<dim>)
      if (parameters.scheme == entry.name)
        return entry.make(parameters, is_incompressible);
    AssertThrow(false, ExcInternalError()); // the pattern refuses other names
    return nullptr;
  }

  template class TimeScheme<2>;
  template class TimeScheme<3>;
  template std::unique_ptr<TimeScheme<2>>
  make_time_scheme<2>(const TimeSchemeParameters &, const bool);
  template std::unique_ptr<TimeScheme<3>>
  make_time_scheme<3>(const TimeSchemeParameters &, const bool);
} // namespace seiche
