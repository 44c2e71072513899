// SPDX-License-Identifier: BSD-3-Clause
#include <voxeland/disambiguation/AnswerParser.h>

int main()
{
    return voxeland::categoryNamedBy("a cup", {}).has_value() ? 1 : 0;
}
