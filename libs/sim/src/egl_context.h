#pragma once

namespace flownav::sim {

/// A context of OpenGL without a window. MRPT's own renderer leaves the context that was made last as the
/// current one, and ends the display of all others with the first of them; these live side by side.
class EglContext {
  public:
    /// Throws std::runtime_error when no device can render. The context is the current one afterwards.
    EglContext();
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    /// To be called before everything that OpenGL is to do in it.
    void make_current() const;

  private:
    void* display_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace flownav::sim
