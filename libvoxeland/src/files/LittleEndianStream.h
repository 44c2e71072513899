// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/core/reverse_bytes.h>

#include <ostream>

namespace voxeland
{
/** Writes numbers little-endian, whatever the machine. */
class LittleEndianStream
{
 public:
    explicit LittleEndianStream(std::ostream& out) : m_out(out) {}
    template <typename T>
    LittleEndianStream& operator<<(T value)
    {
        value = mrpt::toNativeEndianness(value);
        m_out.write(reinterpret_cast<const char*>(&value), sizeof(value));
        return *this;
    }

 private:
    std::ostream& m_out;
};
}  // namespace voxeland
