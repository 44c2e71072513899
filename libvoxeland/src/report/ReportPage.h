// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace voxeland
{
/** \name Content of page.html, page.css, and of table.js and scene.js @{ */
extern const char* const PAGE_HTML;
extern const char* const PAGE_CSS;
extern const char* const PAGE_JS;
/** @} */
}  // namespace voxeland
