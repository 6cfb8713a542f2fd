# Writes a C++ source that holds the files of a folder, each also packed:
#   cmake -DFOLDER=DIR -DPACKED=DIR -DOUT=FILE -P pack_page.cmake
#
# The assembler includes the bytes, so that a new page costs one small source and a link.
file(GLOB_RECURSE files RELATIVE ${FOLDER} ${FOLDER}/*)
list(FILTER files EXCLUDE REGEX "\\.map$")
file(REMOVE_RECURSE ${PACKED})
file(MAKE_DIRECTORY ${PACKED})
set(included "")
set(names "")
set(rows "")
set(index 0)

function(add_bytes name path)
  set(included "${included}.global ${name}\n${name}: .incbin \"${path}\"\n.global ${name}_end\n${name}_end: .byte 0\n" PARENT_SCOPE)
  set(names "${names}extern const char ${name}[], ${name}_end[];\n" PARENT_SCOPE)
endfunction()

foreach(file ${files})
  set(name stepwire_page_${index})
  add_bytes(${name} ${FOLDER}/${file})
  set(packed "{}")
  if(file MATCHES "\\.(js|mjs|css|svg|json|txt|wasm)$")
    execute_process(COMMAND gzip -9 -n -c ${FOLDER}/${file} OUTPUT_FILE ${PACKED}/${index}.gz COMMAND_ERROR_IS_FATAL ANY)
    add_bytes(${name}_packed ${PACKED}/${index}.gz)
    set(packed "{${name}_packed, ${name}_packed_end}")
  endif()
  string(APPEND rows "    {\"/${file}\", {${name}, ${name}_end}, ${packed}},\n")
  math(EXPR index "${index} + 1")
endforeach()

set(table "{}")
set(head "")
if(index GREATER 0)
  set(head "asm(R\"asm(.section .rodata\n${included}.text)asm\");\n\nextern \"C\" {\n${names}}\n\n")
  set(table "rows")
  set(rows "  static const PageFile rows[]{\n${rows}  };\n")
endif()
file(WRITE ${OUT} "// Made from the page by pack_page.cmake.\n#include \"engine/app/studio/page_table.hpp\"\n\n${head}namespace stepwire::studio {

std::span<const PageFile> page_table() {
${rows}  return ${table};
}

}  // namespace stepwire::studio\n")
