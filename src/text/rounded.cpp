// SPDX-License-Identifier: MIT
#include "text/rounded.h"

#include <cmath>

#include "text/compose.h"

namespace kdm {

std::string rounded(double value) {
  double scale = 1;
  while (value * scale < 100 && scale < 1e300) scale *= 10;
  return compose("{}", std::round(value * scale) / scale);
}

}  // namespace kdm
