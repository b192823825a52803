// A scene with five mistakes. Each message gives line, path, value if any, and what is allowed.
#include <contact/scene/scene_file.hpp>
#include <cstdio>

int main() {
  const char* const text = R"({
  "format": "contact-scene/1", "units": "SI", "name": "mistakes",
  "about": "Two balls, and more mistakes than balls.",
  "gravity": [0, 0, -10],
  "materials": [{ "name": "rubber", "restitution": 1.2, "friction": 0 }],
  "bodies": [
    { "name": "a", "shape": { "type": "sphere", "radius": 0.5 }, "material": "ruber", "mass": 1,
      "position": [0, 0, 0] },
    { "name": "b", "shape": { "type": "sphere", "radius": 0.5 }, "material": "rubber", "mass": 0,
      "position": [1.5, 0, 0], "colour": "red" }
  ],
  "duration": 1,
  "tolerance": {}
})";
  try {
    contact::scenes::scene_from_text(text, "mistakes.json");
  } catch (const contact::scenes::SceneFileError& error) {
    std::printf("%s\n", error.what());
  }
}
