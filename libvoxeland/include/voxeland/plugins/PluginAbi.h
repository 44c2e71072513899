// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/** The inline namespace of the plugin bases. To be counted up whenever a base, or anything that
 * its functions take or give (an Opinion, an Overlap, an OptionList, the map), changes: a plugin
 * built for another version then fails to load, with a text that says so, instead of crashing. */
#define VOXELAND_PLUGIN_ABI abi_5
