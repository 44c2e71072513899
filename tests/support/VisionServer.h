// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <sys/types.h>

namespace voxeland::test
{
/** The program tests/vision_server, running while this lives. */
class VisionServer
{
 public:
    /** \param folder where requests are kept; empty: nowhere
     *  \throws std::runtime_error if it does not start */
    explicit VisionServer(const std::string& folder = "");
    ~VisionServer();
    VisionServer(const VisionServer&) = delete;
    VisionServer& operator=(const VisionServer&) = delete;

    /** Its base_url. \param behaviour one of tests/vision_server/main.cpp; empty: a good one */
    [[nodiscard]] std::string url(const std::string& behaviour = "") const;
    /** Ends it: from now on nobody listens at url(). */
    void stop();

 private:
    pid_t m_process = -1;
    std::string m_port;
};
}  // namespace voxeland::test
