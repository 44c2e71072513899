// SPDX-License-Identifier: BSD-3-Clause
#include <voxeland/datasets/LabelMap.h>

int main()
{
    return voxeland::LabelMap::paper9().classes().size() == 9 ? 0 : 1;
}
