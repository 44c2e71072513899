// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** Where Debian's package libjs-three puts its files. */
inline constexpr const char* THREE_FOLDER = "/usr/share/javascript/three";

/** The JavaScript library three.js, which draws 3D in a browser. */
struct ThreeLibrary
{
    std::string core;           //!< text of three.min.js
    std::string orbitControls;  //!< text of OrbitControls.js, not as a module

    /** \param folder holds three.min.js and examples/js/controls/OrbitControls.js
     *  \throws ConfigurationError if they are not there */
    static ThreeLibrary fromFolder(const std::string& folder = THREE_FOLDER);
};
}  // namespace voxeland
