// The sample book's figure has the name of this file; its picture is in web/.
