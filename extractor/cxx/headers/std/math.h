// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdlib.h>
// One overload for double and one template for the other arithmetic types stand for the usual three plus integers.
#ifdef __cplusplus
extern "C++" {
namespace rosarch_math {
template <class T> struct real {};
template <> struct real<rosarch_healed::unknown> { typedef double type; };
template <> struct real<float> { typedef float type; };
template <> struct real<double> { typedef double type; };
template <> struct real<long double> { typedef long double type; };
#define ROSARCH_INT(T) template <> struct real<T> { typedef double type; };
ROSARCH_INT(bool) ROSARCH_INT(char) ROSARCH_INT(signed char) ROSARCH_INT(unsigned char) ROSARCH_INT(short) ROSARCH_INT(unsigned short)
ROSARCH_INT(int) ROSARCH_INT(unsigned) ROSARCH_INT(long) ROSARCH_INT(unsigned long) ROSARCH_INT(long long) ROSARCH_INT(unsigned long long)
#undef ROSARCH_INT
template <class A, class B> using wider = decltype(typename real<A>::type() + typename real<B>::type());
}
}
#define ROSARCH_MATH_1(name) \
  extern "C" double name(double); \
  extern "C" float name##f(float); \
  extern "C++" { template <class T> typename rosarch_math::real<T>::type name(T); }
#define ROSARCH_MATH_2(name) \
  extern "C" double name(double, double); \
  extern "C" float name##f(float, float); \
  extern "C++" { template <class A, class B> rosarch_math::wider<A, B> name(A, B); }
#else
#define ROSARCH_MATH_1(name) double name(double); float name##f(float);
#define ROSARCH_MATH_2(name) double name(double, double); float name##f(float, float);
#endif
ROSARCH_MATH_1(sin) ROSARCH_MATH_1(cos) ROSARCH_MATH_1(tan) ROSARCH_MATH_1(asin) ROSARCH_MATH_1(acos) ROSARCH_MATH_1(atan)
ROSARCH_MATH_1(sinh) ROSARCH_MATH_1(cosh) ROSARCH_MATH_1(tanh) ROSARCH_MATH_1(asinh) ROSARCH_MATH_1(acosh) ROSARCH_MATH_1(atanh)
ROSARCH_MATH_1(exp) ROSARCH_MATH_1(exp2) ROSARCH_MATH_1(expm1) ROSARCH_MATH_1(log) ROSARCH_MATH_1(log2) ROSARCH_MATH_1(log10)
ROSARCH_MATH_1(log1p) ROSARCH_MATH_1(sqrt) ROSARCH_MATH_1(cbrt) ROSARCH_MATH_1(floor) ROSARCH_MATH_1(ceil) ROSARCH_MATH_1(round)
ROSARCH_MATH_1(trunc) ROSARCH_MATH_1(rint) ROSARCH_MATH_1(nearbyint) ROSARCH_MATH_1(fabs) ROSARCH_MATH_1(erf) ROSARCH_MATH_1(erfc)
ROSARCH_MATH_1(tgamma) ROSARCH_MATH_1(lgamma) ROSARCH_MATH_1(logb)
ROSARCH_MATH_2(pow) ROSARCH_MATH_2(atan2) ROSARCH_MATH_2(fmod) ROSARCH_MATH_2(hypot) ROSARCH_MATH_2(fmax) ROSARCH_MATH_2(fmin)
ROSARCH_MATH_2(fdim) ROSARCH_MATH_2(copysign) ROSARCH_MATH_2(remainder) ROSARCH_MATH_2(nextafter)
#undef ROSARCH_MATH_1
#undef ROSARCH_MATH_2
#ifdef __cplusplus
extern "C" {
#endif
long lround(double); long long llround(double); long lrint(double); long long llrint(double);
long lroundf(float); long lrintf(float);
double fma(double, double, double);
double modf(double, double*); float modff(float, float*);
double frexp(double, int*); double ldexp(double, int); double scalbn(double, int); int ilogb(double);
double nan(const char*); float nanf(const char*);
double j0(double); double j1(double); double y0(double); double y1(double);
void sincos(double, double*, double*);
#ifdef __cplusplus
}
#endif
long double sqrtl(long double); long double fabsl(long double); long double powl(long double, long double);
long double sinl(long double); long double cosl(long double); long double floorl(long double); long double ceill(long double);
#ifdef __cplusplus
extern "C++" {
float modf(float, float*);
template <class T> bool isnan(T); template <class T> bool isinf(T); template <class T> bool isfinite(T);
template <class T> bool isnormal(T); template <class T> bool signbit(T); template <class T> int fpclassify(T);
template <class A, class B> bool isgreater(A, B); template <class A, class B> bool isless(A, B);
}
#else
int isnan(double); int isinf(double); int isfinite(double); int isnormal(double); int signbit(double); int fpclassify(double);
int isgreater(double, double); int isless(double, double);
#endif
#define HUGE_VAL __builtin_huge_val()
#define HUGE_VALF __builtin_huge_valf()
#define INFINITY __builtin_inff()
#define NAN __builtin_nanf("")
#define FP_NAN 0
#define FP_INFINITE 1
#define FP_ZERO 2
#define FP_SUBNORMAL 3
#define FP_NORMAL 4
#define MAXFLOAT 3.40282347e+38F
#define M_E 2.71828182845904523536
#define M_LOG2E 1.44269504088896340736
#define M_LOG10E 0.43429448190325182765
#define M_LN2 0.693147180559945309417
#define M_LN10 2.30258509299404568402
#define M_PI 3.14159265358979323846
#define M_PIl 3.14159265358979323846L
#define M_PI_2 1.57079632679489661923
#define M_PI_4 0.785398163397448309616
#define M_1_PI 0.318309886183790671538
#define M_2_PI 0.636619772367581343076
#define M_2_SQRTPI 1.12837916709551257390
#define M_SQRT2 1.41421356237309504880
#define M_SQRT1_2 0.707106781186547524401
