#include "egl_context.h"

// Declares the functions of the extensions, too
#define EGL_EGLEXT_PROTOTYPES 1
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <stdexcept>
#include <string>

namespace flownav::sim {
namespace {

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error("simulated camera: " + what + " (EGL says " + std::to_string(eglGetError()) +
                             "). Rendering without a display needs EGL and a driver; Debian: libegl1 and "
                             "libgl1-mesa-dri.");
}

/// The first device that can be used, as MRPT chooses it. A display is never ended: everybody in the process
/// who asks for this device has the same one.
EGLDisplay open_display() {
    const auto query_devices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto display_of =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (query_devices == nullptr || display_of == nullptr) fail("EGL knows no devices");
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (query_devices(devices.size(), devices.data(), &count) == EGL_FALSE) fail("EGL lists no devices");
    for (EGLint i = 0; i < count; ++i) {
        EGLDisplay display = display_of(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
    }
    fail("no device can render");
}

EGLConfig choose_config(EGLDisplay display) {
    constexpr std::array<EGLint, 15> wanted = {EGL_SURFACE_TYPE,
                                               EGL_PBUFFER_BIT,
                                               EGL_RED_SIZE,
                                               8,
                                               EGL_GREEN_SIZE,
                                               8,
                                               EGL_BLUE_SIZE,
                                               8,
                                               EGL_DEPTH_SIZE,
                                               24,
                                               EGL_CONFORMANT,
                                               EGL_OPENGL_BIT,
                                               EGL_RENDERABLE_TYPE,
                                               EGL_OPENGL_BIT,
                                               EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &count) == EGL_FALSE || count < 1)
        fail("no fitting pixel format");
    return config;
}

}  // namespace

EglContext::EglContext() : display_(open_display()) {
    EGLConfig config = choose_config(display_);
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail("no OpenGL");
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT) fail("no context");
    make_current();
}

EglContext::~EglContext() {
    if (eglGetCurrentContext() == context_)
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

void EglContext::make_current() const {
    if (eglGetCurrentContext() == context_) return;
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
        fail("the context cannot be used");
}

}  // namespace flownav::sim
