// SPDX-License-Identifier: BSD-3-Clause
#include "support/VisionServer.h"

#include <csignal>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace voxeland::test
{
ServerProcess::ServerProcess(const std::vector<std::string>& command)
{
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    m_process = fork();
    if (m_process == 0) {
        prctl(PR_SET_PDEATHSIG, SIGTERM);  // not to outlive a test that crashes
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        execvp(arguments[0], arguments.data());
        _exit(1);
    }
    close(ends[1]);
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) m_port += c;
    close(ends[0]);
    if (!m_port.empty()) return;
    stop();
    throw std::runtime_error(command.at(0) + " does not start");
}

ServerProcess::~ServerProcess()
{
    stop();
}

void ServerProcess::stop()
{
    if (m_process <= 0) return;
    kill(m_process, SIGTERM);
    waitpid(m_process, nullptr, 0);
    m_process = -1;
}

VisionServer::VisionServer(const std::string& folder)
    : ServerProcess(
          {std::string(VOXELAND_TEST_BINARY_DIR) + "/tests/vision_server/vision_server", folder})
{
}

std::string VisionServer::url(const std::string& behaviour) const
{
    return "http://127.0.0.1:" + port() + (behaviour.empty() ? "" : "/" + behaviour) + "/v1";
}
}  // namespace voxeland::test
