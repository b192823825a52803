# The tag under which a C++ exception travels: one 32-bit address.
	.globl	__cpp_exception
	.tagtype __cpp_exception i32
__cpp_exception:
