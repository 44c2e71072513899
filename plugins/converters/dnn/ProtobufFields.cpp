// SPDX-License-Identifier: BSD-3-Clause
#include "ProtobufFields.h"

namespace voxeland
{
uint64_t ProtobufFields::readInteger()
{
    uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        const auto byte = static_cast<uint8_t>(readBytes(1).front());
        value |= static_cast<uint64_t>(byte & 0x7F) << shift;
        if (byte < 0x80) return value;
    }
    throw std::invalid_argument("a protobuf integer has no end");
}

std::string_view ProtobufFields::readBytes(uint64_t count)
{
    if (count > m_rest.size()) throw CutOff();
    const std::string_view bytes = m_rest.substr(0, count);
    m_rest.remove_prefix(count);
    return bytes;
}

bool ProtobufFields::next()
{
    if (m_rest.empty()) return false;
    const uint64_t tag = readInteger();
    m_number = tag >> 3;
    m_integer = 0;
    m_content = {};
    enum WireType : uint64_t
    {
        VARINT = 0,
        FIXED64 = 1,
        LENGTH = 2,
        FIXED32 = 5
    };
    switch (tag & 7) {
        case VARINT:
            m_integer = readInteger();
            break;
        case FIXED64:
            readBytes(8);
            break;
        case LENGTH:
            m_content = readBytes(readInteger());
            break;
        case FIXED32:
            readBytes(4);
            break;
        default:
            throw std::invalid_argument("no protobuf message");
    }
    if (m_number == 0) throw std::invalid_argument("no protobuf message");
    return true;
}
}  // namespace voxeland
