// SPDX-License-Identifier: BSD-3-Clause
/** Runs a fuzz target on files, and on those of folders, without a fuzzer. */
#include "Reading.h"
#include "support/TestFiles.h"

#include <filesystem>
#include <iostream>

namespace fs = std::filesystem;

namespace
{
void runOn(const fs::path& file)
{
    std::cout << file.string() << std::endl;
    const std::string content = voxeland::test::readFile(file);
    LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(content.data()), content.size());
}
}  // namespace

int main(int argc, char** argv)
{
    size_t files = 0;
    for (int i = 1; i < argc; ++i)
        for (const auto& entry : fs::directory_iterator(argv[i])) {
            runOn(entry.path());
            ++files;
        }
    if (files == 0) std::cerr << "there is no file to run on\n";
    return files == 0 ? 1 : 0;
}
