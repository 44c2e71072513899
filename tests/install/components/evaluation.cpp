// SPDX-License-Identifier: BSD-3-Clause
#include <voxeland/evaluation/UncertaintyMeasures.h>

int main()
{
    return voxeland::expectedCalibrationError({{0.75, true}}) == 0.25 ? 0 : 1;
}
