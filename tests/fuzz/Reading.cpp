// SPDX-License-Identifier: BSD-3-Clause
#include "Reading.h"

#include "support/TestFiles.h"

#include <mrpt/core/backtrace.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <zlib.h>

namespace fs = std::filesystem;

/** MRPT's own names every function that an exception came through, which takes most of the time of
 *  who makes damaged files. Another definition than theirs, which is found first. */
void mrpt::callStackBackTrace(TCallStackBackTrace&, unsigned, unsigned) noexcept {}

namespace voxeland::fuzz
{
namespace
{
void checkSentence(const std::exception& refusal)
{
    const std::string sentence = refusal.what();
    if (!sentence.empty() && sentence.size() <= 1000) return;
    std::cerr << "a refusal of " << sentence.size() << " characters\n";
    std::abort();
}

std::string textOf(const uint8_t* data, size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}
}  // namespace

int readOrRefuse(const std::function<void()>& read)
{
    try {
        read();
    } catch (const ConfigurationError& e) {
        checkSentence(e);
    } catch (const PluginError& e) {
        checkSentence(e);
    } catch (const InputError& e) {
        checkSentence(e);
    } catch (const NothingToMapError& e) {
        checkSentence(e);
    }
    return 0;
}

MadeUpFile::MadeUpFile(const std::string& name) : m_folder("made_up_" + name), m_path(beside(name))
{
    fs::create_directories(m_folder);
}

MadeUpFile::~MadeUpFile()
{
    std::error_code ignored;
    fs::remove_all(m_folder, ignored);
}

std::string MadeUpFile::beside(const std::string& name) const
{
    return m_folder + "/" + name;
}

const std::string& MadeUpFile::holding(const uint8_t* data, size_t size) const
{
    test::writeFile(m_path, textOf(data, size));
    return m_path;
}

const std::string& MadeUpFile::compressing(const uint8_t* data, size_t size) const
{
    const gzFile out = gzopen(m_path.c_str(), "wb1");
    gzwrite(out, data, static_cast<unsigned>(size));
    gzclose(out);
    return m_path;
}
}  // namespace voxeland::fuzz
