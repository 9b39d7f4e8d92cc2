plugins { application }

dependencies {
    implementation(project(":argo-arch"))
    implementation(libs.jason)
    implementation(libs.jmh.core)
    annotationProcessor(libs.jmh.processor)
}

application {
    mainClass = "benchmarks.MainKt"
    applicationDefaultJvmArgs = listOf("--enable-native-access=ALL-UNNAMED") // jSerialComm loads a native library
}
