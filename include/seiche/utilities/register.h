// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_register_h
#define seiche_utilities_register_h

#include <cstring>

namespace seiche
{
  template <unsigned int width>
  struct RegisterTypes;
  template <>
  struct RegisterTypes<2>
  {
    typedef double Doubles __attribute__((vector_size(2 * sizeof(double))));
    typedef float  Floats __attribute__((vector_size(2 * sizeof(float))));
  };
  template <>
  struct RegisterTypes<4>
  {
    typedef double Doubles __attribute__((vector_size(4 * sizeof(double))));
    typedef float  Floats __attribute__((vector_size(4 * sizeof(float))));
  };

  /**
   * @brief A few doubles that the compiler keeps in one vector register.
   *
   * For products of small blocks, which compilers do not vectorise on their
   * own. (GCC's and Clang's vector extension, for any instruction set;
   * dealii::VectorizedArray is as wide as deal.II's own build, two doubles in
   * Debian's.) @p n: up to 4; for 3, four numbers are read and the last means
   * nothing: one more must follow an array. (Three numbers copied through
   * memory would be read before they are all written, and each product would
   * wait for that.)
   */
  template <unsigned int n>
  struct Register
  {
    using Doubles = typename RegisterTypes<n == 3 ? 4 : n>::Doubles;
    using Floats  = typename RegisterTypes<n == 3 ? 4 : n>::Floats;

    static Doubles
    load(const double *from)
    {
      return gather<Doubles>(from);
    }

    static Doubles
    load(const float *from)
    {
      return __builtin_convertvector(gather<Floats>(from), Doubles);
    }

  private:
    template <typename Numbers, typename Number>
    static Numbers
    gather(const Number *from)
    {
      Numbers result;
      std::memcpy(&result, from, sizeof(Numbers));
      return result;
    }
  };
} // namespace seiche

#endif
