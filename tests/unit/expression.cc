// SPDX-License-Identifier: LGPL-2.1-or-later
// Expressions: values, what depends on what, and the refused forms.
#include <seiche/scene/body_force.h>
#include <seiche/scene/expression.h>

#include <iomanip>

#include "scene_from_text.h"

namespace
{
  void
  evaluate(const seiche::InputFile &input, const std::string &text)
  {
    const seiche::Expression<2> f(input, "Some/Entry", text, 2);
    const dealii::Tensor<1, 2>  v =
      f.vector_value(dealii::Point<2>(0.5, 0.25), /*t=*/2.);
    std::cout << text << " = " << v << " constant " << f.is_constant()
              << std::endl;
  }



  void
  refuse(const seiche::InputFile &input, const std::string &text)
  {
    print_input_error([&]() {
      const seiche::Expression<2> f(
        input, "Some/Entry", text, 1, dealii::Point<2>(0.5, 0.5));
      f.value(dealii::Point<2>(0., 0.), 0.);
    });
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const seiche::InputFile input(file_with("set Dimension = 2\n"), {});
  std::cout << std::setprecision(10);

  for (const char *text : {"0; 0",
                           "0; -9.81",
                           "1e-1; 2.5E+0*e",
                           "x + 2*y; -y",
                           "sin(pi*x)*t; t^2",
                           "min(x, y); max(x, min(2, 3))",
                           "if(x > 0.1, 1, 2); x >= 0.6 && y == 0.25 ? 1 : 3"})
    evaluate(input, text);

  for (const char *text : {"x, y",
                           "0,5",
                           "(x, y)",
                           "y = 3",
                           "rand()",
                           "x +",
                           "sin(",
                           "foo(x)",
                           "z",
                           "1; 2",
                           "",
                           "1/x",
                           "sqrt(x - 0.1)",
                           "0/0",
                           "\"a\"",
                           "x # y",
                           "2 x"})
    refuse(input, text);

  seiche::BodyForceParameters<3> parameters;
  parameters.acceleration = "0; 0; -9.81*cos(t)";
  const seiche::TankMotion<3> at_rest(seiche::TankMotionParameters<3>(),
                                      seiche::GridParameters<3>(input),
                                      input,
                                      /*end_time=*/1.,
                                      /*step=*/0.1);
  const seiche::BodyForce<3>  force(parameters, at_rest, input);
  std::cout << force.value(dealii::Point<3>(), 0.) << " constant "
            << force.is_constant() << std::endl;
}
