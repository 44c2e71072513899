// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/CocoPredictions.h"

#include <nlohmann/json.hpp>

namespace voxeland
{
/** Fills a CocoPredictions from JSON, checking every field. */
class CocoReader
{
 public:
    /** \param names category names that win over COCO's */
    CocoReader(CocoPredictions& target, const CategoryNames& names);

    /** \throws InputError as CocoPredictions' constructor */
    void read(const nlohmann::json& root);

 private:
    void readCategories(const nlohmann::json& list);
    void readImages(const nlohmann::json& list);
    void readPrediction(const nlohmann::json& prediction);
    void readSegmentation(const nlohmann::json& segmentation, CocoPredictions::Entry& entry) const;
    [[nodiscard]] CategoryDistribution readCategory(const nlohmann::json& prediction) const;
    [[nodiscard]] PixelBox readBox(const nlohmann::json& box) const;

    [[nodiscard]] double number(const nlohmann::json& value, const char* what) const;
    [[nodiscard]] int64_t integer(const nlohmann::json& object, const char* key) const;
    [[nodiscard]] std::string nameOf(int64_t category) const;
    [[noreturn]] void fail(const std::string& what) const;

    CocoPredictions& m_target;
    const CategoryNames& m_givenNames;
    CategoryNames m_ownNames;  //!< the file's "categories"
    size_t m_index = 0;        //!< of the prediction being read, from 0
    std::string m_image;       //!< its image_id, for messages
};
}  // namespace voxeland
