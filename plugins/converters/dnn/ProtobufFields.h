// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace voxeland
{
/** Goes through the fields of a serialized protobuf message, of which only the numbers are known.
 * See protobuf.dev/programming-guides/encoding. */
class ProtobufFields
{
 public:
    /** The message ends before its last field does. */
    struct CutOff : std::runtime_error
    {
        CutOff() : std::runtime_error("a protobuf message is cut off") {}
    };

    /** \param message must outlive this */
    explicit ProtobufFields(std::string_view message) : m_rest(message) {}

    /** Goes to the next field, the first one at first; false at the end.
     *  \throws CutOff, or std::invalid_argument for what is no protobuf message */
    bool next();

    [[nodiscard]] uint64_t number() const { return m_number; }
    /** Value of a field of an integer type, otherwise 0. */
    [[nodiscard]] uint64_t integer() const { return m_integer; }
    /** Content of a field that is a text, bytes or a message, otherwise empty. */
    [[nodiscard]] std::string_view content() const { return m_content; }

 private:
    uint64_t readInteger();
    std::string_view readBytes(uint64_t count);

    std::string_view m_rest, m_content;
    uint64_t m_number = 0, m_integer = 0;
};
}  // namespace voxeland
