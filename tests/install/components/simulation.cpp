// SPDX-License-Identifier: BSD-3-Clause
#include <voxeland/simulation/Random.h>

int main()
{
    return voxeland::simulation::Random(7).uniform() < 1 ? 0 : 1;
}
