// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <sys/types.h>
#include <vector>

namespace voxeland::test
{
/** A server on 127.0.0.1 that prints its port first; it runs while this lives. */
class ServerProcess
{
 public:
    /** \param command program and arguments
     *  \throws std::runtime_error if it does not start */
    explicit ServerProcess(const std::vector<std::string>& command);
    ~ServerProcess();
    ServerProcess(const ServerProcess&) = delete;
    ServerProcess& operator=(const ServerProcess&) = delete;

    [[nodiscard]] const std::string& port() const { return m_port; }
    /** Ends it: from now on nobody listens at the port. */
    void stop();

 private:
    pid_t m_process = -1;
    std::string m_port;
};

/** The program tests/vision_server. */
class VisionServer : public ServerProcess
{
 public:
    /** \param folder where requests are kept; empty: nowhere */
    explicit VisionServer(const std::string& folder = "");

    /** Its base_url. \param behaviour one of tests/vision_server/main.cpp; empty: a good one */
    [[nodiscard]] std::string url(const std::string& behaviour = "") const;
};
}  // namespace voxeland::test
