// SPDX-License-Identifier: MIT
// kdm_fuzz_seeds FOLDER: files for the corpus of the target that loads saved grids.
#include <cstdio>
#include <fstream>
#include <string>

#include "grid_seeds.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: kdm_fuzz_seeds FOLDER\n", stderr);
    return 2;
  }
  int number = 0;
  for (const kdm::fuzz::Bytes& seed : kdm::fuzz::grid_seeds()) {
    std::ofstream file(std::string(argv[1]) + "/seed-" + std::to_string(number++),
                       std::ios::binary);
    file.write(reinterpret_cast<const char*>(seed.data()),
               static_cast<std::streamsize>(seed.size()));
    if (!file.flush()) {
      std::perror("kdm_fuzz_seeds");
      return 1;
    }
  }
  return 0;
}
