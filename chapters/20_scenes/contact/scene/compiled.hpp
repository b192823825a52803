/// @file
/// Where the functions of this chapter are defined. Either src/ is compiled once into a library,
/// or, without the library, each program that includes a header includes its source too. A program
/// that links the library defines CONTACT_SCENES_COMPILED, as the build's target contact_scenes
/// does.
#pragma once

/// @cond
#ifdef CONTACT_SCENES_COMPILED
#define CONTACT_SCENES_INLINE
#else
#define CONTACT_SCENES_INLINE inline
#endif
/// @endcond
