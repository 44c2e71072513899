// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace voxeland::simulation
{
/** What the simulated apartment is like. */
struct SceneOptions
{
    int rooms = 2;                 //!< 1 to 3, in a row, joined by door openings
    float roomHeight = 2.6F;       //!< [m]
    float pairProbability = 0.6F;  //!< of a second sofa, or table, touching the first one
    float clutterPerTable = 5.0F;  //!< mean number of things standing on a table
    float unknownPerRoom = 3.0F;   //!< mean number of objects the detector has no word for
    bool painted = false;          //!< objects have the colour of their category (CategoryPaint.h)
};

/** The camera and the hand that carries it. */
struct CameraOptions
{
    int width = 640, height = 480;   //!< image size [pixels]; the field of view stays the same
    int frames = 300;                //!< the tour through all rooms is spread over so many frames
    float frameRate = 30;            //!< of the timestamps [Hz]
    float focalLength = 525;         //!< [pixels of an image 640 wide]
    float carryHeight = 1.45F;       //!< mean height over the floor [m]
    float shakeTranslation = 0.01F;  //!< amplitude of the hand's shaking [m]
    float shakeRotation = 0.8F;      //!< amplitude of the hand's shaking [deg]
    float maxGroundTruthRange = 4;   //!< surfaces farther than this do not count as seen [m]
};

/** Errors of the depth image, after measurements of the Kinect (Nguyen, Izadi, Lovell 2012). */
struct DepthNoiseOptions
{
    bool enabled = true;            //!< false: exact depth, rounded to millimetres
    float axialConstant = 0.0012F;  //!< sigma(z) = constant + factor * (z - offset)^2 [m]
    float axialFactor = 0.0019F;    //!< [1/m]
    float axialOffset = 0.4F;       //!< [m]
    float lateralSigma = 0.6F;      //!< of the jitter across the image [pixels of 640]
    float disparityStep = 0.125F;   //!< quantum of the disparity [pixels of 640]; 0: none
    float baseline = 0.075F;        //!< between projector and camera [m]
    float minRange = 0.45F;         //!< nothing is measured nearer than this [m]
    float maxRange = 6.0F;          //!< nothing is measured farther than this [m]
    float grazingDropout = 0.12F;   //!< lost where the cosine to the normal is below this
    float edgeDropout = 0.5F;       //!< probability of loss at a depth discontinuity
    float randomDropout = 0.004F;   //!< probability of loss anywhere
};

/** Errors of the poses written to the rawlog: a random walk, 0 at the first frame. */
struct DriftOptions
{
    bool enabled = false;
    float translation = 0.01F;  //!< standard deviation after 1 m of way [m]
    float rotation = 0.25F;     //!< standard deviation of the heading after 1 m of way [deg]
};

/** A robot on wheels that carries the camera on a mast which pans, tilts and lifts it, and has a
 *  level laser scanner. The poses in the rawlog are the robot's: on the floor, heading where the
 *  camera looks. */
struct RobotOptions
{
    bool enabled = false;  //!< false: the camera is all there is, and the poses are its own
    DriftOptions odometry{true, 0.03F, 1.0F};  //!< errors of the wheels' odometry
    float laserHeight = 0.3F;                  //!< over the floor [m]
    float laserAperture = 270;                 //!< [deg], centred on the robot's heading
    int laserRays = 541;
    float laserMaxRange = 10;  //!< [m]
    float laserSigma = 0.01F;  //!< standard deviation of a range [m]
};

/** Errors of single poses written to the rawlog, as of a localization that is unsure now and then:
 *  each frame has one of its own, and how large they are on average changes with time. */
struct JitterOptions
{
    bool enabled = false;
    int period = 30;           //!< frames after which the standard deviations change
    float translation = 0.1F;  //!< greatest standard deviation along x and y [m]; of z a third;
                               //!< the current one is this times u^3, u being uniform in [0,1)
    float rotation = 3;        //!< the same for the heading [deg]; of pitch and roll a third
};

/** How wrong the simulated detector is. All probabilities are per object and frame unless a
 *  comment says otherwise; lengths in the image refer to one 640 pixels wide. */
struct DetectorOptions
{
    float detectionRate = 0.9F;     //!< of large, near, unoccluded objects
    float halfRateArea = 350;       //!< visible pixels at which the rate has fallen to a half
    float halfRateVisible = 0.25F;  //!< visible share of an object at which it has, too
    float scoreThreshold = 0.3F;    //!< detections with a lower score are not reported
    float falseDetections = 0.1F;   //!< mean number of detections of nothing, per frame

    float confidence = 3.5F;         //!< advantage of the right category's logit
    float logitNoise = 0.8F;         //!< standard deviation of all logits, new in every frame
    float confusedObjects = 0.5F;    //!< share of objects that look like something else from a side
    float confusedSector = 110;      //!< width of the directions from which they do [deg]
    float confusion = 5.0F;          //!< logit of the wrong category from there
    float unknownConfidence = 3.5F;  //!< advantage of the wrong name given to an unknown object

    float boundaryBias = 0.5F;        //!< masks are grown by this on average [pixels]
    float boundaryNoise = 1.5F;       //!< standard deviation of a mask's boundary [pixels]
    float maskShift = 1.0F;           //!< standard deviation of a mask's position [pixels]
    float underSegmentation = 0.08F;  //!< a mask also covers a touching object
    float swallowing = 0.3F;          //!< a mask also covers a thing standing on the object
    float overSegmentation = 0.06F;   //!< a mask covers only a part of the object
    float splitting = 0.03F;          //!< an object is detected in two pieces
    float duplicates = 0.06F;         //!< an object is detected twice, as different things

    bool tracks = false;  //!< true: `track` tells the true identity, for yardsticks

    /** \param name `perfect` (exact masks and categories), `mild`, `realistic` or `hard`
     *  \throws ConfigurationError for another name */
    static DetectorOptions preset(const std::string& name);
    /** The names preset() knows. */
    static const std::vector<std::string>& presets();
};

/** Everything that determines a simulation: equal options give equal bytes. */
struct SimulationOptions
{
    uint64_t seed = 1;
    SceneOptions scene;
    CameraOptions camera;
    DepthNoiseOptions depth;
    DriftOptions drift;
    RobotOptions robot;
    JitterOptions jitter;
    DetectorOptions detector;
    float groundTruthSpacing = 0.02F;  //!< between points of the ground truth, at most [m]

    /** \throws ConfigurationError naming the first setting that makes no sense */
    void check() const;
};
}  // namespace voxeland::simulation
