// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/** \file Reading from archives that anybody may have written. Sizes in them are not believed: what
 * is read grows with what is really there. All throw what CArchive does where it ends. */
namespace voxeland
{
/** What MRPT writes for a list of values that have no pointers: their number, and them.
 *  \tparam Values std::string or a std::vector of numbers
 *  \throws std::runtime_error if there are more than `most` */
template <typename Values>
Values readValues(mrpt::serialization::CArchive& in, size_t most)
{
    constexpr size_t AT_ONCE = 1 << 16;
    const size_t count = in.ReadAs<uint32_t>();
    if (count > most)
        throw std::runtime_error("a list of " + std::to_string(count) + " values is too long");
    Values values;
    while (values.size() < count) {
        const size_t begin = values.size(), more = std::min(AT_ONCE, count - begin);
        values.resize(begin + more);
        const size_t bytes = more * sizeof(values[0]);
        if (in.ReadBufferFixEndianness(&values[begin], more) != bytes)
            throw std::runtime_error("a list ends before its last value");
    }
    return values;
}

/** A text as MRPT writes it. */
inline std::string readText(mrpt::serialization::CArchive& in)
{
    constexpr size_t LONGEST = size_t{1} << 26;
    return readValues<std::string>(in, LONGEST);
}

/** A bool as MRPT writes it, which may be any byte. */
inline bool readTruth(mrpt::serialization::CArchive& in)
{
    return in.ReadAs<uint8_t>() != 0;
}

/** An object of a class or of one derived from it. \throws std::runtime_error for another one */
template <typename Class>
std::shared_ptr<Class> readObject(mrpt::serialization::CArchive& in)
{
    const auto object = std::dynamic_pointer_cast<Class>(in.ReadObject());
    if (!object) throw std::runtime_error("an object is of another class than it should be");
    return object;
}
}  // namespace voxeland
