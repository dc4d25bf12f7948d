# cmake -DOUTPUT=x.cpp -DTEMPLATE=... -DSTYLE=... -DSCRIPT=... -P embed.cmake
# Turns the bundled page into a C++ source with the definition of voronaut::web_assets().
cmake_minimum_required(VERSION 3.22)

# A content security policy wants base64, CMake hashes in hexadecimal: three bytes make four digits.
function(hex_to_base64 hex result)
  set(digits "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
  set(text "")
  foreach(start RANGE 0 54 6)
    string(SUBSTRING "${hex}" ${start} 6 group)
    foreach(shift 18 12 6 0)
      math(EXPR index "(0x${group} >> ${shift}) & 63")
      string(SUBSTRING "${digits}" ${index} 1 digit)
      string(APPEND text "${digit}")
    endforeach()
  endforeach()
  string(SUBSTRING "${hex}" 60 4 group)  # the last two of the 32 bytes
  foreach(shift 10 4)
    math(EXPR index "(0x${group} >> ${shift}) & 63")
    string(SUBSTRING "${digits}" ${index} 1 digit)
    string(APPEND text "${digit}")
  endforeach()
  math(EXPR index "(0x${group} << 2) & 63")
  string(SUBSTRING "${digits}" ${index} 1 digit)
  set(${result} "${text}${digit}=" PARENT_SCOPE)
endfunction()

set(source "#include \"voronaut/reports/page/web_assets.h\"\n\nnamespace voronaut {\n\nnamespace {\n\n")
foreach(asset TEMPLATE STYLE SCRIPT)
  file(READ "${${asset}}" hex HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${hex}")
  string(APPEND source "constexpr char k${asset}[] = {${bytes}};\n\n")
  file(SHA256 "${${asset}}" hash)
  hex_to_base64(${hash} ${asset}_HASH)
endforeach()
string(APPEND source
  "}  // namespace\n\n"
  "WebAssets web_assets() {\n"
  "  return {{kTEMPLATE, sizeof kTEMPLATE},\n"
  "          {kSTYLE, sizeof kSTYLE},\n"
  "          \"sha256-${STYLE_HASH}\",\n"
  "          {kSCRIPT, sizeof kSCRIPT},\n"
  "          \"sha256-${SCRIPT_HASH}\"};\n"
  "}\n\n}  // namespace voronaut\n")
file(WRITE "${OUTPUT}" "${source}")
