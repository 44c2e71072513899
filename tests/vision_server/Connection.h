// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <optional>
#include <string>

namespace voxeland::test
{
/** A request to the test server. */
struct Request
{
    std::string path, body;
    std::map<std::string, std::string> headers;  //!< names in lower case
};

/** One client of the test server, over a socket, which it closes at the end. */
class Connection
{
 public:
    explicit Connection(int socket) : m_socket(socket) {}
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /** None if the client left before it was complete. */
    std::optional<Request> receive();
    /** \param headers lines that end in CR LF \param promised what Content-Length says more than
     * there is: the answer then breaks off */
    void answer(int status, const std::string& body, const std::string& headers = "",
                size_t promised = 0);

 private:
    int m_socket;
};
}  // namespace voxeland::test
