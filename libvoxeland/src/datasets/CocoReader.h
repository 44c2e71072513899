// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "CategoryNumbering.h"
#include "voxeland/datasets/CocoPredictions.h"

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <stdexcept>

namespace voxeland
{
/** Fills a CocoPredictions from JSON, checking every field. */
class CocoReader
{
 public:
    /** \param names category names; if there are any, COCO's do not count */
    CocoReader(CocoPredictions& target, const CategoryNames& names);

    /** \throws InputError as CocoPredictions' constructor */
    void read(const nlohmann::json& root);

 private:
    /** What is odd about an entry. */
    struct OddEntry : std::runtime_error
    {
        using std::runtime_error::runtime_error;
    };

    [[nodiscard]] const nlohmann::json& listIn(const nlohmann::json& root,
                                               nlohmann::json& byImage) const;
    void readCategories(const nlohmann::json& list);
    void readImages(const nlohmann::json& list);
    void learnNumbering(const nlohmann::json& list, bool mayNameImages);
    void readPrediction(const nlohmann::json& prediction);
    [[nodiscard]] size_t imageOf(const nlohmann::json& prediction);
    size_t addImage(CocoPredictions::Image image);
    void readSegmentation(const nlohmann::json& segmentation, CocoPredictions::Entry& entry);
    void readPolygons(const nlohmann::json& segmentation, CocoPredictions::Entry& entry);
    void readRunLengths(const nlohmann::json& segmentation, CocoPredictions::Entry& entry);
    void readBox(const nlohmann::json& prediction, CocoPredictions::Entry& entry);
    [[nodiscard]] CategoryDistribution readCategory(const nlohmann::json& prediction) const;
    void keepMostMaskSize();
    void checkImageSizes();
    void checkBoxes();

    void leaveOut(const std::string& problem);

    CocoPredictions& m_target;
    const CategoryNames& m_givenNames;
    CategoryNames m_ownNames;  //!< the file's "categories"
    std::optional<CategoryNumbering> m_numbering;
    std::map<std::string, size_t> m_imageById, m_imageByName;
    std::map<std::pair<int, int>, size_t> m_maskSizes;  //!< how many masks are of width, height
    size_t m_boxes = 0, m_boxesApart = 0,
           m_boxesOfRows = 0;  //!< bboxes that were compared with masks
    PixelBox m_alongRows;      //!< of the mask read last, if its runs were along the rows
    size_t m_place = 0;        //!< of the prediction being read, from 0
    std::string m_image;       //!< its image_id, for messages
};
}  // namespace voxeland
