// The sample book's figure is known by this file's name; its picture stands in web/.
