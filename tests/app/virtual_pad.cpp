// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/virtual_pad.h"

#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>
#include <dlfcn.h>

namespace fulcrum::app::program_test {
namespace {

constexpr int pad_buttons = 15, pad_axes = 6;

class PadOfSdl : public VirtualPad {
  public:
    bool begin(const char* name) {
        library_ = dlopen("libSDL2-2.0.so.0", RTLD_NOW | RTLD_LOCAL);
        if (library_ == nullptr) return false;
        find(init_, "SDL_InitSubSystem");
        find(quit_, "SDL_QuitSubSystem");
        find(attach_, "SDL_JoystickAttachVirtualEx");
        find(detach_, "SDL_JoystickDetachVirtual");
        find(open_, "SDL_JoystickOpen");
        find(axis_, "SDL_JoystickSetVirtualAxis");
        find(button_, "SDL_JoystickSetVirtualButton");
        if (attach_ == nullptr || init_(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER) != 0) return false;
        SDL_VirtualJoystickDesc description{};
        description.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
        description.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
        description.naxes = pad_axes;
        description.nbuttons = pad_buttons;
        description.name = name;
        description.Rumble = [](void*, Uint16, Uint16) { return 0; };
        index_ = attach_(&description);
        pad_ = index_ >= 0 ? open_(index_) : nullptr;
        for (const int trigger : {SDL_CONTROLLER_AXIS_TRIGGERLEFT, SDL_CONTROLLER_AXIS_TRIGGERRIGHT})
            if (pad_ != nullptr) set_axis(trigger, 0);
        return pad_ != nullptr;
    }
    ~PadOfSdl() override {
        if (index_ >= 0) detach_(index_);
        if (index_ >= 0) quit_(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER);
    }
    void set_axis(int axis, std::int32_t value) override {
        // A trigger of a virtual controller has the range of a stick.
        if (axis >= SDL_CONTROLLER_AXIS_TRIGGERLEFT) value = 2 * value - 32768;
        axis_(pad_, axis, static_cast<Sint16>(value));
    }
    void set_buttons(std::uint32_t held) override {
        for (int i = 0; i < pad_buttons; ++i)
            button_(pad_, i, static_cast<Uint8>(held >> static_cast<unsigned>(i) & 1U));
    }

  private:
    template <typename Function>
    void find(Function& function, const char* name) {
        function = reinterpret_cast<Function>(dlsym(library_, name));
    }
    void* library_ = nullptr;
    decltype(&SDL_InitSubSystem) init_ = nullptr;
    decltype(&SDL_QuitSubSystem) quit_ = nullptr;
    decltype(&SDL_JoystickAttachVirtualEx) attach_ = nullptr;
    decltype(&SDL_JoystickDetachVirtual) detach_ = nullptr;
    decltype(&SDL_JoystickOpen) open_ = nullptr;
    decltype(&SDL_JoystickSetVirtualAxis) axis_ = nullptr;
    decltype(&SDL_JoystickSetVirtualButton) button_ = nullptr;
    int index_ = -1;
    SDL_Joystick* pad_ = nullptr;
};

}  // namespace

std::unique_ptr<VirtualPad> make_pad_of_sdl(const char* name) {
    auto pad = std::make_unique<PadOfSdl>();
    return pad->begin(name) ? std::move(pad) : nullptr;
}

}  // namespace fulcrum::app::program_test
