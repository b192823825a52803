/// @file
/// Where the functions of this chapter are defined: in src/, which is compiled once into a library,
/// or, without the library, in every program that includes a header, which then takes its source
/// in. Who links the library defines CONTACT_SCENES_COMPILED; the build's target contact_scenes
/// does.
#pragma once

/// @cond
#ifdef CONTACT_SCENES_COMPILED
#define CONTACT_SCENES_INLINE
#else
#define CONTACT_SCENES_INLINE inline
#endif
/// @endcond
