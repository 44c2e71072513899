// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/errors.h"
#include "voxeland/io/GzInputFile.h"
#include "voxeland/io/GzOutputFile.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservationComment.h>

#include <random>

using namespace voxeland;
using voxeland::test::TemporaryFolder;

namespace
{
mrpt::obs::CObservationComment comment(const std::string& text)
{
    mrpt::obs::CObservationComment c;
    c.text = text;
    return c;
}

/** Text that does not compress. */
std::string noise(size_t bytes)
{
    std::mt19937 random(1);
    std::string text(bytes, ' ');
    for (char& c : text) c = static_cast<char>(random());
    return text;
}

void writeThree(const std::string& file, int compression = 1)
{
    GzOutputFile out(file, compression);
    for (const size_t size : {10U, 30000U, 20U}) out.writeObject(comment(noise(size)));
    out.close();
}

std::vector<std::string> readAll(const std::string& file)
{
    std::vector<std::string> texts;
    GzInputFile in(file);
    while (const auto object = in.readObject())
        texts.push_back(dynamic_cast<mrpt::obs::CObservationComment&>(*object).text);
    return texts;
}
}  // namespace

TEST(GzOutputFile, noticesAFullDevice)
{
    GzOutputFile file("/dev/full");
    file.Write("abc", 3);  // stays in zlib's buffer
    EXPECT_THROW(file.close(), OutputError);
}

TEST(GzOutputFile, noticesAFullDeviceInTheMiddleOfAnObject)
{
    GzOutputFile file("/dev/full");
    try {
        file.writeObject(comment(noise(1000000)));
        FAIL() << "no exception";
    } catch (const OutputError& e) {
        EXPECT_STREQ(e.what(),
                     "cannot write /dev/full: No space left on device: free some space or choose "
                     "another place");
    }
}

TEST(GzInputFile, readsWhatWasWritten)
{
    const TemporaryFolder folder;
    writeThree(folder.file("f"));
    EXPECT_EQ(readAll(folder.file("f")),
              (std::vector<std::string>{noise(10), noise(30000), noise(20)}));
}

TEST(GzInputFile, objectBytesMakeTheSameFileAgain)
{
    const TemporaryFolder folder;
    writeThree(folder.file("f"));
    {
        GzInputFile in(folder.file("f"));
        GzOutputFile out(folder.file("copy"));
        while (in.readObject()) out.Write(in.objectBytes().data(), in.objectBytes().size());
        EXPECT_NEAR(in.progress(), 1, 1e-9);
        out.close();
    }
    EXPECT_EQ(readAll(folder.file("copy")), readAll(folder.file("f")));
}

TEST(GzInputFile, noticesAFileThatIsCutAnywhere)
{
    const TemporaryFolder folder;
    writeThree(folder.file("f"));
    const std::string whole = test::readFile(folder.file("f"));
    for (const size_t cut : {size_t{1}, size_t{4}, size_t{9}, whole.size() / 2}) {
        test::writeFile(folder.file("cut"), whole.substr(0, whole.size() - cut));
        EXPECT_THROW(readAll(folder.file("cut")), InputError) << cut << " bytes missing";
    }
    test::writeFile(folder.file("cut"), "");
    EXPECT_TRUE(readAll(folder.file("cut")).empty());
}

TEST(GzInputFile, noticesADamagedFileAndOneOfSomethingElse)
{
    const TemporaryFolder folder;
    writeThree(folder.file("f"));
    std::string bytes = test::readFile(folder.file("f"));
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
    test::writeFile(folder.file("damaged"), bytes);
    EXPECT_THROW(readAll(folder.file("damaged")), InputError);
    test::writeFile(folder.file("text"), "This is no rawlog at all, just a text.");
    EXPECT_THROW(readAll(folder.file("text")), InputError);
    EXPECT_THROW(readAll(folder.file("missing")), InputError);
    EXPECT_THROW(readAll(folder.path().string()), InputError);
}

TEST(GzInputFile, tellsAnObjectOfANewerVersionFromDamage)
{
    const TemporaryFolder folder;
    writeThree(folder.file("f"), 0);
    GzInputFile in(folder.file("f"));
    in.readObject();
    std::string bytes = in.objectBytes();
    bytes[1 + std::string("mrpt::obs::CObservationComment").size()] = 99;
    test::writeFile(folder.file("newer"), bytes);
    try {
        readAll(folder.file("newer"));
        FAIL() << "no exception";
    } catch (const InputError& e) {
        EXPECT_EQ(e.what(), folder.file("newer") +
                                " after 0 bytes: an object of a newer version than is known here; "
                                "was it written with a newer MRPT?");
    }
}
