// placeholder until the first source file of this module exists
