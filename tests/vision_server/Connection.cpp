// SPDX-License-Identifier: BSD-3-Clause
#include "Connection.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <sys/socket.h>
#include <unistd.h>

namespace voxeland::test
{
namespace
{
std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}
}  // namespace

Connection::~Connection()
{
    close(m_socket);
}

std::optional<Request> Connection::receive()
{
    static const std::string END = "\r\n\r\n";
    std::string received;
    const auto receiveMore = [&] {
        char buffer[65536];
        const ssize_t bytes = recv(m_socket, buffer, sizeof(buffer), 0);
        if (bytes > 0) received.append(buffer, static_cast<size_t>(bytes));
        return bytes > 0;
    };
    while (received.find(END) == std::string::npos)
        if (!receiveMore()) return std::nullopt;

    Request request;
    const size_t bodyBegin = received.find(END) + END.size();
    std::istringstream head(received.substr(0, bodyBegin));
    std::string method;
    head >> method >> request.path;
    for (std::string line; std::getline(head, line);) {
        const size_t colon = line.find(": ");
        if (colon != std::string::npos)
            request.headers[lowerCase(line.substr(0, colon))] =
                line.substr(colon + 2, line.find('\r') - colon - 2);
    }
    const size_t bytes = std::stoul("0" + request.headers["content-length"]);
    while (received.size() < bodyBegin + bytes)
        if (!receiveMore()) return std::nullopt;
    request.body = received.substr(bodyBegin);
    return request;
}

void Connection::answer(int status, const std::string& body, const std::string& headers,
                        size_t promised)
{
    const std::string text =
        "HTTP/1.1 " + std::to_string(status) +
        " so it is\r\nContent-Type: application/json\r\nConnection: close\r\n" + headers +
        "Content-Length: " + std::to_string(body.size() + promised) + "\r\n\r\n" + body;
    for (size_t sent = 0; sent < text.size();) {
        const ssize_t bytes = send(m_socket, &text[sent], text.size() - sent, MSG_NOSIGNAL);
        if (bytes <= 0) return;
        sent += static_cast<size_t>(bytes);
    }
}
}  // namespace voxeland::test
