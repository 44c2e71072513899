// SPDX-License-Identifier: BSD-3-Clause
/** Shows that it was loaded: makes the file that the environment variable VOXELAND_TEST_MARK names.
 */
#include <cstdlib>
#include <fstream>

[[gnu::constructor]] static void mark()
{
    if (const char* file = std::getenv("VOXELAND_TEST_MARK")) std::ofstream(file) << "loaded";
}
