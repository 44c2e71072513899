// SPDX-License-Identifier: BSD-3-Clause
/** Runs MRPT's programs with Voxeland's classes. */
#include "RawlogEntries.h"
#include "common/CommandLine.h"
#include "common/TrustPathsArgument.h"
#include "common/runProgram.h"
#include "plugins/PluginLoader.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/InputFile.h"
#include "voxeland/metric_map/CVoxelandMap.h"

#include <mrpt/apps/ICP_SLAM_App.h>
#include <mrpt/apps/MonteCarloLocalization_App.h>
#include <mrpt/apps/RBPF_SLAM_App.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/system/string_utils.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <set>
#include <unistd.h>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION =
    R"(Runs one of MRPT's programs so that it knows Voxeland's maps, predictions and plugins.

  voxeland-run icp-slam icp-slam.ini robot.rawlog
  voxeland-run rbpf-slam rbpf-slam.ini robot.rawlog
  voxeland-run pf-localization pf-localization.ini robot.rawlog
  voxeland-run observations2map observations2map.ini robot.simplemap map
  voxeland-run rawlog-edit --info -i robot.rawlog
  voxeland-run RawLogViewer robot.rawlog

icp-slam, rbpf-slam and pf-localization are MRPT's own application classes, run by this program. It
also finds what lies beside the rawlog: external images, and predictions in NAME.instances.rawlog.
Any other program is started in this one's place with libvoxeland preloaded, and its exit code is its
own. With --quiet or -v WARN, MRPT's applications show errors alone: they warn about every frame that
is not a laser scan.
INI files to start from are in share/config/mrpt of the sources, and once installed in
share/voxeland/config/mrpt of the place of installation, such as /usr.
Usage: voxeland-run [option]... <PROGRAM> [its arguments]...
Exit codes: 0 done, 1 usage or configuration, 2 plugin, 3 input, or MRPT's application failed,
5 output.)";

/** One of MRPT's applications, reading rawlogs with what lies beside them.
 *  \tparam WANTS_FRAMES whether it would crash on a rawlog without actions and sensory frames */
template <class Application, bool WANTS_FRAMES = false>
class WithVoxeland : public Application
{
 public:
    bool trustsPaths = false;  //!< see checkImagePaths()

 protected:
    bool impl_get_next_observations(mrpt::obs::CActionCollection::Ptr& actions,
                                    mrpt::obs::CSensoryFrame::Ptr& frame,
                                    mrpt::obs::CObservation::Ptr& observation) override
    {
        if (!m_entries)
            m_entries = std::make_unique<apps::RawlogEntries>(this->m_rawlogFileName, trustsPaths);
        std::optional<apps::RawlogEntries::Entry> entry;
        do {
            entry = m_entries->next();
            if (!entry) return false;
            this->m_rawlogEntry = m_entries->objectsRead();
        } while (this->m_rawlogEntry < this->m_rawlog_offset);
        if (WANTS_FRAMES && !entry->frame)
            throw InputError(this->m_rawlogFileName +
                             " consists of single observations; this application needs actions and "
                             "sensory frames (RawLogViewer converts it)");
        actions = entry->actions;
        frame = entry->frame;
        observation = entry->observation;
        return true;
    }

 private:
    std::unique_ptr<apps::RawlogEntries> m_entries;
};

/** What a section's name says of the map that it is about, as
 *  "MappingApplication_voxelandMap_00" in "MappingApplication_voxelandMap_00_creationOpts"; empty
 *  if it is about none of ours. */
std::string mapOf(const std::string& section)
{
    static const std::string CLASS = "voxelandmap_";
    const std::string name = mrpt::system::lowerCase(section);
    const size_t found = name.rfind(CLASS);
    if (found == std::string::npos) return {};
    std::string before = name.substr(0, found);
    for (const std::string part : {"c", "voxeland::"})
        if (before.size() >= part.size() &&
            before.compare(before.size() - part.size(), part.size(), part) == 0)
            before.resize(before.size() - part.size());
    const size_t number = found + CLASS.size();
    const size_t end = name.find_first_not_of("0123456789", number);
    const bool isMap = !before.empty() && before.back() == '_' && end != std::string::npos &&
                       end > number && name[end] == '_';
    return isMap ? section.substr(0, end) : std::string();
}

/** Checks the Voxeland maps that an INI defines, before MRPT does: what is thrown inside its
 *  applications arrives as an exception of its own. \throws ConfigurationError, PluginError */
void checkMaps(const std::string& ini)
{
    const mrpt::config::CConfigFile config(ini);
    std::vector<std::string> sections;
    config.getAllSections(sections);
    std::set<std::string> maps;
    for (const std::string& section : sections)
        if (const std::string map = mapOf(section); !map.empty()) maps.insert(map);
    for (const std::string& map : maps)
        CVoxelandMap::TMapDefinition().loadFromConfigFile(config, map);
}

/** This program's own command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION, Rest::command) {}

    apps::TrustPathsArgument trustPaths{*this};
};

/** What MRPT's applications say of an INI for programmers, in words for users; empty if it is
 *  something else. */
std::string problemOfIni(const std::string& message, const std::string& ini)
{
    static const std::string BEGIN = "Value '", MIDDLE = "' not found in section '";
    const size_t key = message.find(BEGIN), middle = message.find(MIDDLE);
    if (key != std::string::npos && middle != std::string::npos) {
        const size_t section = middle + MIDDLE.size();
        return "'" + ini + "' has no key '" +
               message.substr(key + BEGIN.size(), middle - key - BEGIN.size()) +
               "' in its section [" +
               message.substr(section, message.find('\'', section) - section) +
               "]: add it (share/config/mrpt has complete ones)";
    }
    if (message.find("Neither grid maps nor points map") != std::string::npos)
        return "'" + ini +
               "' defines neither a grid map nor a points map, which icp-slam needs: add one "
               "(share/config/mrpt has complete ones)";
    return {};
}

/** \param arguments the application's name and arguments, as its main() would get them */
template <class Application>
int runApplication(Application& application, Arguments& options, int count, char** arguments)
{
    application.setMinLoggingLevel(options.quiet() ? mrpt::system::LVL_ERROR : options.verbosity());
    application.trustsPaths = options.trustPaths.isSet();
    const std::string ini = count > 1 ? arguments[1] : "";
    try {
        if (!ini.empty()) checkInputFile(ini, "the INI");  // MRPT would wait for a pipe
        application.initialize(count, arguments);
    } catch (const std::exception& e) {
        const std::string problem = problemOfIni(apps::sentence(e), ini);
        throw ConfigurationError(problem.empty() ? apps::sentence(e) : problem);
    }
    checkMaps(ini);
    try {
        application.run();
    } catch (const std::exception& e) {
        const std::string problem = problemOfIni(apps::sentence(e), ini);
        if (!problem.empty()) throw ConfigurationError(problem);
        throw;
    }
    return 0;
}

/** Becomes another program. \throws ConfigurationError if that is not possible */
[[noreturn]] void become(char** command)
{
    std::string preload = libraryFile();
    if (const char* others = std::getenv("LD_PRELOAD")) preload += std::string(":") + others;
    setenv("LD_PRELOAD", preload.c_str(), 1);
    execvp(command[0], command);
    throw ConfigurationError("cannot run '" + std::string(command[0]) +
                             "': " + std::strerror(errno) +
                             "; MRPT's programs are in the package "
                             "mrpt-apps");
}

int run(int argc, char** argv)
{
    Arguments options;
    if (!options.parse(argc, argv)) return 0;
    const auto count = static_cast<int>(options.wordsOfCommand());
    if (count == 0) throw ConfigurationError("name a program of MRPT to run (see --help)");
    char** const command = argv + argc - count;
    const std::string name = command[0];
    if (name == "icp-slam") {
        WithVoxeland<mrpt::apps::ICP_SLAM_App_Rawlog> application;
        application.quits_with_esc_key = false;
        return runApplication(application, options, count, command);
    }
    if (name == "rbpf-slam") {
        WithVoxeland<mrpt::apps::RBPF_SLAM_App_Rawlog, true> application;
        application.quits_with_esc_key = false;
        return runApplication(application, options, count, command);
    }
    if (name == "pf-localization") {
        WithVoxeland<mrpt::apps::MonteCarloLocalization_Rawlog> application;
        application.allow_quit_on_esc_key = false;
        return runApplication(application, options, count, command);
    }
    become(command);
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-run", [&] { return run(argc, argv); });
}
