// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"

#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace voxeland::test
{
TemporaryFolder::TemporaryFolder()
{
    std::random_device random;
    do {
        m_path = fs::temp_directory_path() / ("voxeland_test_" + std::to_string(random()));
    } while (!fs::create_directories(m_path));
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

fs::path redkitchen()
{
    const fs::path folder = fs::path(VOXELAND_TEST_DATA) / "7scenes_redkitchen";
    return fs::exists(folder) ? folder : fs::path();
}

std::string readFile(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    std::ostringstream content;
    content << in.rdbuf();
    return content.str();
}

void writeFile(const fs::path& file, const std::string& content)
{
    std::ofstream out(file, std::ios::binary);
    out << content;
    if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}
}  // namespace voxeland::test
