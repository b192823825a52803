// WebAssembly unwinds its own stack: there is no cursor and no register to describe. Upstream's header of this
// name knows the processors only, and stops at any other.
#ifndef ____LIBUNWIND_CONFIG_H__
#define ____LIBUNWIND_CONFIG_H__

#define _LIBUNWIND_VERSION 15000
#define _LIBUNWIND_CURSOR_SIZE 0
#define _LIBUNWIND_CONTEXT_SIZE 0
#define _LIBUNWIND_HIGHEST_DWARF_REGISTER 0

#endif
