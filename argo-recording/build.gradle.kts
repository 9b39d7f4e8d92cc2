plugins {
    `java-library`
    alias(libs.plugins.kotlin.serialization)
}

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(libs.serialization.json) // what the messages of a recording are written in
    testImplementation(libs.jason)
}
