# Writes a .cpp that holds files as text. Called by luch_embed() at build time:
# cmake -DOUT=file.cpp -DHEADER=… -DFILES=name=path,name=path -P embed.cmake
set(text "#include \"${HEADER}\"\n\nnamespace luch::embedded {\nnamespace {\n")
set(functions "")
string(REPLACE "," ";" files "${FILES}")
foreach(file IN LISTS files)
  string(REGEX MATCH "^([a-z_]+)=(.*)$" ignored "${file}")
  set(name ${CMAKE_MATCH_1})
  file(READ ${CMAKE_MATCH_2} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(APPEND text "constexpr unsigned char ${name}_bytes[] = {${bytes}};\n")
  string(APPEND functions "std::string_view ${name}() {\n"
         "    return {reinterpret_cast<const char*>(${name}_bytes), sizeof(${name}_bytes)};\n}\n")
endforeach()
file(WRITE ${OUT} "${text}}  // namespace\n\n${functions}\n}  // namespace luch::embedded\n")
