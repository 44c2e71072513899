// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>

namespace voxeland
{
/** Section [disambiguation] without the back-end's own keys: what is asked, and what an answer is
 * worth. */
struct DisambiguationOptions
{
    double entropy_threshold = 0.6;   //!< instances above it are asked about [nat]
    uint32_t min_voxels = 20;         //!< smaller instances are not asked about
    bool ask_again = false;           //!< also about instances that have a decision
    uint32_t max_questions = 0;       //!< of a run, the most uncertain first; 0: no limit
    uint32_t max_categories = 3;      //!< candidates of a question
    uint32_t views_per_category = 3;  //!< M in the paper
    double crop_margin = 0.25;        //!< around the object, in shares of its longer side
    uint32_t picture_size = 512;      //!< longer side of a picture [pixels]
    bool whole_frame = false;         //!< also show the best view's whole frame
    bool voxel_picture = true;        //!< also show the reconstructed geometry
    std::string prompt;               //!< file of the prompt's template; empty: the built-in one
    uint32_t max_attempts = 3;        //!< questions until an answer can be used
    uint32_t parallel = 4;            //!< questions asked at a time
    double answer_reliability = 0.9;  //!< share of answers that are right, in [0.5, 0.999]
    double prompt_price = 0;          //!< of a million tokens of question, in any currency
    double answer_price = 0;          //!< of a million tokens of answer
};
}  // namespace voxeland
