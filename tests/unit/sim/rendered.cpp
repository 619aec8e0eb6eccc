#include "rendered.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <vector>

namespace flownav::sim {
cv::Mat1b picture_of(const Field& field) {
    cv::Mat1b picture(field.image.height_px, field.image.width_px);
    for (int v = 0; v < picture.rows; ++v)
        std::copy(field.image.row(v), field.image.row(v) + picture.cols, picture[v]);
    return picture;
}

CameraSimParams clean(const CameraModel& camera, int supersampling) {
    CameraSimParams params;
    params.camera = camera;
    params.supersampling = supersampling;
    params.effects.noise_sigma = 0.0;
    return params;
}

cv::Point2d mean_shift(const cv::Mat1b& from, const cv::Mat1b& to) {
    std::vector<cv::Point2f> points;
    std::vector<cv::Point2f> moved;
    std::vector<unsigned char> found;
    std::vector<float> errors;
    cv::goodFeaturesToTrack(from, points, 200, 0.05, 12.0);
    cv::calcOpticalFlowPyrLK(from, to, points, moved, found, errors);
    cv::Point2d sum;
    int count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (found[i] == 0) continue;
        sum += cv::Point2d(moved[i] - points[i]);
        ++count;
    }
    return count > 20 ? sum / count : cv::Point2d(NAN, NAN);
}

}  // namespace flownav::sim
